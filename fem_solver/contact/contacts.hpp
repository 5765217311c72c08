// SPDX-License-Identifier: MIT
#pragma once

#include "fem_solver/contact/ground_contact.hpp"

namespace fem {

/// All contacts of the body, as one.
class Contacts final : public ContactForce {
public:
    void add(std::unique_ptr<GroundContact> contact) { all_.push_back(std::move(contact)); }
    const std::vector<std::unique_ptr<GroundContact>>& all() const { return all_; }

    double stiffness() const override
    {
        double largest = 0;
        for (const auto& contact : all_) largest = std::max(largest, contact->stiffness());
        return largest;
    }
    void restore() override
    {
        for (auto& contact : all_) contact->restore();
    }
    void add_force(const Motion& motion, double time, Eigen::VectorXd& normal, Eigen::VectorXd& friction) const override
    {
        for (const auto& contact : all_) contact->add_force(motion, time, normal, friction);
    }
    void add_tangent(const Motion& motion, double time, Matrix& matrix) const override
    {
        for (const auto& contact : all_) contact->add_tangent(motion, time, matrix);
    }
    Augmentation augment(const Motion& motion, double time) override
    {
        Augmentation worst = Augmentation::settled;
        for (auto& contact : all_) worst = std::max(worst, contact->augment(motion, time));
        return worst;
    }
    std::string complaint() const override
    {
        std::string all;
        for (const auto& contact : all_)
            if (const std::string one = contact->complaint(); !one.empty()) all += (all.empty() ? "" : "; ") + one;
        return all;
    }
    void accept(const Motion& motion, double time) override
    {
        for (auto& contact : all_) contact->accept(motion, time);
    }

private:
    std::vector<std::unique_ptr<GroundContact>> all_;
};

} // namespace fem
